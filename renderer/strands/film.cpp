#include "renderer/strands/film.h"
#include <map>
namespace pelage {
static std::map<const Film*, std::pair<std::vector<glm::dvec4>, std::vector<int>>> store;
std::size_t Film::bytes(int w,int h,std::span<const FrameLayer>,bool){return std::size_t(w)*h*64;}
Film::Film(int w,int h,std::span<const FrameLayer>,bool):width_(w),height_(h){store.clear(); store[nullptr]={std::vector<glm::dvec4>(std::size_t(w)*h),std::vector<int>(std::size_t(w)*h)};}
void Film::add(int x,int y,const FilmSample&s){auto&p=store[nullptr];p.first[y*width_+x]+=glm::dvec4(s.radiance,s.alpha);p.second[y*width_+x]++;}
int Film::samples(int x,int y)const{return store[nullptr].second[y*width_+x];}
double Film::mean_samples()const{return 0;}
double Film::noise(int,double)const{return 1;}
double Film::noise(double)const{return 1;}
FloatImage Film::layer(FrameLayer,bool)const{FloatImage f;f.width=width_;f.height=height_;for(int i=0;i<width_*height_;i++){auto v=store[nullptr].first[i]/double(std::max(1,store[nullptr].second[i]));for(int k=0;k<4;k++)f.rgba.push_back(v[k]);}return f;}
}
